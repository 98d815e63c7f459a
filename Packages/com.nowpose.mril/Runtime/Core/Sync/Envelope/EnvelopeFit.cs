using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Fits one curve to the lower and the upper bounds of the offset, with a separate constant term (height) for each. The estimated offset is
    /// halfway between the two heights. A prior determines the slope and the quadratic term (bend) if the data do not determine them.
    /// </summary>
    sealed class EnvelopeFit
    {
        /// <summary>
        /// Standard deviation of the bend, 1/s: a skew that changes by 1 ppm in 100 s. The skew of quartz clocks in a room changes more slowly. With
        /// this value, the fit follows changes in a quiet network that could not be distinguished from noise in a busy network.
        /// </summary>
        const double BendPrior = 5e-9;

        const int Iterations = 3;

        /// <summary>
        /// Factor by which the standard errors from the weights are increased, because delays are not normally distributed and clock rates
        /// vary. On four simulated networks, 95 % of the errors were within 1.8 to 3.8 increased standard errors, depending on the network;
        /// for normally distributed errors it would be 2.
        /// </summary>
        const double ErrorFactor = 2;

        /// <summary>Minimum weight of the data on the slope relative to the weight of the prior; keeps the error finite.</summary>
        const double MinShare = 1e-6;

        readonly EnvelopeSide _below, _above;
        double _xx, _xz, _zz, _xy, _zy;
        Height _heightBelow, _heightAbove;

        public EnvelopeFit(EnvelopeSide below, EnvelopeSide above) => (_below, _above) = (below, above);

        public OffsetCurve Curve { get; private set; }

        /// <summary>Offset at the reference time minus the reference offset, s.</summary>
        public double Offset => (_heightBelow.At(Curve) + _heightAbove.At(Curve)) / 2;

        /// <summary>Standard error of <see cref="Offset"/>, s.</summary>
        public double OffsetError { get; private set; }

        /// <summary>
        /// Standard error of the slope, dimensionless. It is computed from the data without the prior, and includes the shift that the prior causes.
        /// </summary>
        public double SlopeError { get; private set; }

        /// <param name="scatter">Maximum difference between bounds that are equally accurate, plus the control clock's resolution, s.</param>
        /// <param name="unsampled">Value of <see cref="UnsampledPart"/>, s.</param>
        /// <param name="start">Initial curve of the iteration.</param>
        /// <param name="slopePrior">Expected slope, dimensionless.</param>
        /// <param name="slopePriorError">Standard deviation of the expected slope, dimensionless.</param>
        /// <param name="step">
        /// Possible step of the heights. X: its time relative to the reference time, s. Deviation: standard deviation of its size, s; 0 if there is
        /// no step.
        /// </param>
        public void Solve(
            double scatter, double unsampled, OffsetCurve start, double slopePrior, double slopePriorError, (double X, double Deviation) step)
        {
            Curve = start;
            var slopeWeight = 1 / (slopePriorError * slopePriorError);
            const double bendWeight = 1 / (BendPrior * BendPrior);
            var groupVariance = step.Deviation * step.Deviation / 2;
            for (var i = 0; i < Iterations; i++)
            {
                _below.Weigh(Curve, scatter, unsampled);
                _above.Weigh(Curve, scatter, unsampled);
                _xx = _xz = _zz = _xy = _zy = 0;
                _heightBelow = Gather(_below, step.X, groupVariance);
                _heightAbove = Gather(_above, step.X, groupVariance);
                var (xx, zz, xy) = (_xx + slopeWeight, _zz + bendWeight, _xy + slopeWeight * slopePrior);
                var determinant = xx * zz - _xz * _xz;
                Curve = new OffsetCurve((xy * zz - _zy * _xz) / determinant, (xx * _zy - _xz * xy) / determinant);
            }
            EstimateErrors(slopePrior, slopeWeight, bendWeight);
        }

        // Adds half of the step's variance to the variance of the height before the step, and half to that of the height after it. The difference of
        // the two means is an additional measurement of the curve.
        Height Gather(EnvelopeSide side, double stepX, double groupVariance)
        {
            // The newest block comes first.
            var split = 0;
            while (split < side.Count && side.X(split) >= stepX) split++;
            var (after, before) = (Gather(side, 0, split), Gather(side, split, side.Count));
            if (before.IsEmpty) return after;
            if (after.IsEmpty) return before;
            var earlier = 1 / (before.Variance + groupVariance);
            var later = 1 / (after.Variance + groupVariance);
            var share = later / (earlier + later);
            Sum(earlier * share, after.X - before.X, after.Z - before.Z, after.Y - before.Y);
            return Height.Mean(before, after, share);
        }

        // Computes sums relative to the weighted means of the blocks, which eliminates the unknown height.
        Height Gather(EnvelopeSide side, int from, int to)
        {
            if (from == to) return default;
            double weights = 0, x = 0, z = 0, y = 0;
            for (var i = from; i < to; i++)
            {
                var weight = side.Weight(i);
                weights += weight;
                x += weight * side.X(i);
                z += weight * side.X(i) * side.X(i);
                y += weight * side.Y(i);
            }
            var height = new Height(1 / weights, x / weights, z / weights, y / weights);
            for (var i = from; i < to; i++)
                Sum(side.Weight(i), side.X(i) - height.X, side.X(i) * side.X(i) - height.Z, side.Y(i) - height.Y);
            return height;
        }

        void Sum(double weight, double dx, double dz, double dy)
        {
            _xx += weight * dx * dx;
            _xz += weight * dx * dz;
            _zz += weight * dz * dz;
            _xy += weight * dx * dy;
            _zy += weight * dz * dy;
        }

        void EstimateErrors(double slopePrior, double slopeWeight, double bendWeight)
        {
            var (xx, zz) = (_xx + slopeWeight, _zz + bendWeight);
            var determinant = xx * zz - _xz * _xz;
            var x = (_heightBelow.X + _heightAbove.X) / 2;
            var z = (_heightBelow.Z + _heightAbove.Z) / 2;
            var variance = (_heightBelow.Variance + _heightAbove.Variance) / 4
                + (x * x * zz - 2 * x * z * _xz + z * z * xx) / determinant;
            OffsetError = ErrorFactor * Math.Sqrt(variance);
            // A single exchange contains no information about the slope.
            var known = Math.Max(_xx - _xz * _xz / zz, MinShare * slopeWeight);
            // Distance by which the prior shifts the slope away from the slope of the data alone.
            var priorShift = slopeWeight / known * Math.Abs(Curve.Slope - slopePrior);
            SlopeError = ErrorFactor * Math.Sqrt(1 / known) + priorShift;
        }

        /// <summary>Weighted means of one side, or of its blocks before or after a step.</summary>
        readonly struct Height
        {
            public Height(double variance, double x, double z, double y) => (Variance, X, Z, Y) = (variance, x, z, y);

            /// <summary>Variance due to the scatter of the bounds, s²; does not include the variance of a step.</summary>
            public double Variance { get; }

            public double X { get; }

            /// <summary>Weighted mean of the squares of x.</summary>
            public double Z { get; }

            public double Y { get; }

            public bool IsEmpty => Variance == 0;

            /// <param name="share">Weight of the second value.</param>
            public static Height Mean(in Height first, in Height second, double share) => new Height(
                (1 - share) * (1 - share) * first.Variance + share * share * second.Variance, Mix(first.X, second.X, share),
                Mix(first.Z, second.Z, share), Mix(first.Y, second.Y, share));

            public double At(OffsetCurve curve) => Y - curve.Slope * X - curve.Bend * Z;

            static double Mix(double first, double second, double share) => first + share * (second - first);
        }
    }
}
