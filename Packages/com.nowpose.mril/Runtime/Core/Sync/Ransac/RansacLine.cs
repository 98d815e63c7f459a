using System;

namespace Nowpose.Sync.Ransac
{
    /// <summary>Random sample consensus for a line: selects the line through two points that has the most points within a bound.</summary>
    static class RansacLine
    {
        /// <returns>
        /// The points within <paramref name="bound"/> of the best line; all points if every line has fewer than two points within the bound.
        /// </returns>
        public static (double[] X, double[] Y) Inliers(double[] x, double[] y, int hypotheses, double bound, Random random)
        {
            int bestCount = 0, bestPoint = 0;
            double bestSlope = 0;
            for (var h = 0; h < hypotheses; h++)
            {
                int i = random.Next(x.Length), k = random.Next(x.Length);
                if (x[i] == x[k]) continue;
                var slope = (y[k] - y[i]) / (x[k] - x[i]);
                var count = Count(x, y, i, slope, bound);
                if (count <= bestCount) continue;
                (bestCount, bestPoint, bestSlope) = (count, i, slope);
            }
            return bestCount < 2 ? (x, y) : Select(x, y, bestPoint, bestSlope, bound, bestCount);
        }

        static bool IsInlier(double[] x, double[] y, int point, int through, double slope, double bound) =>
            Math.Abs(y[point] - y[through] - slope * (x[point] - x[through])) < bound;

        static int Count(double[] x, double[] y, int through, double slope, double bound)
        {
            var count = 0;
            for (var p = 0; p < x.Length; p++)
                if (IsInlier(x, y, p, through, slope, bound)) count++;
            return count;
        }

        static (double[] X, double[] Y) Select(double[] x, double[] y, int through, double slope, double bound, int count)
        {
            var chosenX = new double[count];
            var chosenY = new double[count];
            for (int p = 0, next = 0; p < x.Length; p++)
            {
                if (!IsInlier(x, y, p, through, slope, bound)) continue;
                chosenX[next] = x[p];
                chosenY[next++] = y[p];
            }
            return (chosenX, chosenY);
        }
    }
}
