// The BLAS routines that MUMPS meets, against Eigen, over all their options.
#include <Eigen/Dense>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

// NOLINTBEGIN(readability-identifier-naming): the names of BLAS
extern "C" {
void sgemm_(const char* op_A, const char* op_B, const int* m, const int* n, const int* k,
            const float* alpha, const float* A, const int* lda, const float* B, const int* ldb,
            const float* beta, float* C, const int* ldc);
void strsm_(const char* side, const char* half, const char* op_A, const char* diagonal,
            const int* m, const int* n, const float* alpha, const float* A, const int* lda,
            float* B, const int* ldb);
}
// NOLINTEND(readability-identifier-naming)

namespace {

using Eigen::MatrixXf;

// Room for leading dimensions larger than the matrices.
constexpr int lead = 40;
constexpr float tolerance = 1e-5F;

TEST(OneColumn, the_routines_are_those_of_the_program) {
  for (const char* name : {"sgemm_", "strsm_"}) {
    Dl_info found{};
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, name), &found), 0);
    EXPECT_EQ(std::string(found.dli_sname), name);
    EXPECT_EQ(std::string(found.dli_fname).find("blas"), std::string::npos) << found.dli_fname;
  }
}

// The part of A, m x n after it is transposed or not, of which BLAS speaks.
MatrixXf operand(const MatrixXf& A, char op, int m, int n) {
  if (op == 'N' || op == 'n') return A.topLeftCorner(m, n);
  return A.topLeftCorner(n, m).transpose();
}

TEST(OneColumn, products_are_eigens) {
  const int m = 23, k = 17;
  for (const int n : {1, 3})
    for (const char op_A : {'N', 'T', 'n', 't'})
      for (const char op_B : {'N', 'T'})
        for (const float beta : {0.F, 1.F, -0.5F}) {
          const float alpha = -1.5F;
          const MatrixXf A = MatrixXf::Random(lead, lead), B = MatrixXf::Random(lead, lead);
          MatrixXf C = MatrixXf::Random(lead, n), expected = C;
          const MatrixXf left = operand(A, op_A, m, k), right = operand(B, op_B, k, n);
          expected.topRows(m) = beta * C.topRows(m) + alpha * left * right;
          if (beta == 0) C.topRows(m).setConstant(std::numeric_limits<float>::quiet_NaN());
          sgemm_(&op_A, &op_B, &m, &n, &k, &alpha, A.data(), &lead, B.data(), &lead, &beta,
                 C.data(), &lead);
          EXPECT_TRUE(C.allFinite());
          EXPECT_LT((C - expected).cwiseAbs().maxCoeff(), tolerance * k)
              << op_A << op_B << n << beta;
        }
}

TEST(OneColumn, triangular_solutions_are_eigens) {
  for (const int n : {1, 3})
    for (const char side : {'L', 'R'})
      for (const char half : {'U', 'L', 'u'})
        for (const char op : {'N', 'T'})
          for (const char diagonal : {'U', 'N'}) {
            const int m = 19;
            const bool left = side == 'L';
            const int order = left ? m : n;  // of the triangle
            const float alpha = 0.7F;
            MatrixXf A = MatrixXf::Random(lead, lead) / 8;
            A.diagonal().array() += 2;
            MatrixXf triangle = A.topLeftCorner(order, order);
            if (half == 'L')
              triangle = triangle.triangularView<Eigen::Lower>().toDenseMatrix();
            else
              triangle = triangle.triangularView<Eigen::Upper>().toDenseMatrix();
            if (diagonal == 'U') triangle.diagonal().setOnes();
            if (op == 'T') triangle.transposeInPlace();
            const MatrixXf start = MatrixXf::Random(lead, n);
            MatrixXf x = start;
            strsm_(&side, &half, &op, &diagonal, &m, &n, &alpha, A.data(), &lead, x.data(), &lead);
            const MatrixXf found = x.topRows(m);
            const MatrixXf again = left ? MatrixXf(triangle * found) : MatrixXf(found * triangle);
            EXPECT_LT((again - alpha * start.topRows(m)).cwiseAbs().maxCoeff(), tolerance * m)
                << side << half << op << diagonal << n;
            EXPECT_EQ(x.bottomRows(lead - m), start.bottomRows(lead - m));
          }
}

}  // namespace
