/* papers.h -- control nets that papers print. */
#ifndef TAUT_TEST_PAPERS_H
#define TAUT_TEST_PAPERS_H

/* Examples 1 to 4 of [WuWang2011] section 4, solved: uniform B-splines of one degree both ways, nu
 * x nv points, given on the boundary. */
typedef struct paper_net {
    int degree, nu, nv;
    double points[20][3];
} paper_net;
extern const paper_net wuwang2011[4];

/* [NiWang2015] section 4: the bicubic Bezier surface P, its extension Q and both merged, H. */
extern const double niwang2015_p[16][3], niwang2015_q[16][3], niwang2015_h[16][3];

#endif /* TAUT_TEST_PAPERS_H */
