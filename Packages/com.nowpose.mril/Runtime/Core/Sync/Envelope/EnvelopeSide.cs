using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// One side of the corridor that contains the offset: the tightest bound of each block of exchanges, with the weight of each
    /// block.
    /// </summary>
    /// <remarks>
    /// A packet can only be late, so the error of a bound has a known sign. The weight of a bound is 1/(s² + e² + a²): e is its
    /// distance behind the upper quartile of the blocks, s is the typical distance, and a is the possible effect of changing clock
    /// rates since the time of the bound.
    /// </remarks>
    sealed class EnvelopeSide
    {
        /// <summary>QuartileShare: quantile of the blocks from which e is measured. ScaleShare: quantile of e that gives the scale s.</summary>
        const double QuartileShare = 0.75, ScaleShare = 0.4;

        /// <summary>Minimum scale, s: without it, a few equal time stamps would outweigh all other bounds.</summary>
        const double MinScale = 3e-6;

        /// <summary>
        /// Part of a coarse clock's step into which no exchange falls: fraction of this part that is added to the scale. Half of this value is too
        /// small.
        /// </summary>
        const double UnsampledShare = 0.1;

        /// <summary>Factor k in a = k·age², 1/s: allows for a change of the skew by 2 ppm within 50 s that slope and bend cannot follow.</summary>
        const double AgeGrowth = 2e-8;

        /// <summary>
        /// Number of blocks whose age reduces their weight by at most half. Otherwise the scale could shrink until too few blocks determine it.
        /// </summary>
        const int BlocksAtLeast = 8;

        /// <summary>
        /// The scatter of the round trips, divided by the number of blocks to this power, is added to the scale, because few bounds may agree by
        /// chance, and a line through three late packets can be steep.
        /// </summary>
        const double CountPower = 1.5;

        readonly int _sign;
        readonly double[] _x, _y, _behind, _recency, _weights;
        readonly WeightedQuantile _quantile;
        double _scale;

        /// <param name="sign">1 for bounds below the offset, −1 for bounds above it.</param>
        /// <param name="maxBlocks">Maximum number of blocks.</param>
        public EnvelopeSide(int sign, int maxBlocks)
        {
            _sign = sign;
            _x = new double[maxBlocks];
            _y = new double[maxBlocks];
            _behind = new double[maxBlocks];
            _recency = new double[maxBlocks];
            _weights = new double[maxBlocks];
            _quantile = new WeightedQuantile(maxBlocks);
        }

        public int Count { get; private set; }

        /// <summary>Returns the time of a block's bound relative to the reference time, s.</summary>
        public double X(int block) => _x[block];

        /// <summary>Returns a block's bound minus the reference offset, s.</summary>
        public double Y(int block) => _y[block];

        /// <summary>Returns the weight of a block, 1/s².</summary>
        public double Weight(int block) => _weights[block];

        public void Clear()
        {
            Count = 0;
            // Initially all blocks have the same weight, regardless of their age.
            _scale = double.PositiveInfinity;
        }

        /// <summary>Adds the tightest bound of the next block.</summary>
        public void Add(double x, double y)
        {
            _x[Count] = x;
            _y[Count] = y;
            Count++;
        }

        /// <summary>Computes the weights of the blocks from the distances of their bounds to a curve, whose height has no effect.</summary>
        /// <param name="scatter">See <see cref="EnvelopeFit.Solve"/>, s.</param>
        /// <param name="unsampled">Value of <see cref="UnsampledPart"/>, s.</param>
        public void Weigh(OffsetCurve curve, double scatter, double unsampled)
        {
            var growth = Growth();
            for (var i = 0; i < Count; i++)
            {
                _behind[i] = _sign * (_y[i] - curve.At(_x[i]));
                _recency[i] = double.IsInfinity(_scale) ? 1 : 1 / (1 + Square(growth * _x[i] * _x[i] / _scale));
            }
            _quantile.Fill(_behind, _recency, Count);
            var quartile = _quantile.FromBelow(QuartileShare);
            for (var i = 0; i < Count; i++) _behind[i] = Math.Max(0, quartile - _behind[i]);
            _scale = Math.Max(0, quartile - _quantile.FromAbove(ScaleShare)) + MinScale + UnsampledShare * unsampled
                + scatter / Math.Pow(Count, CountPower);

            growth = Growth();
            for (var i = 0; i < Count; i++)
                _weights[i] = 1 / (_scale * _scale + _behind[i] * _behind[i] + Square(growth * _x[i] * _x[i]));
        }

        /// <summary>Returns the weight of the blocks at or after a time, relative to the weight of all blocks.</summary>
        /// <param name="x">Seconds since the reference time.</param>
        public double WeightShareSince(double x)
        {
            double since = 0, all = 0;
            for (var i = 0; i < Count; i++)
            {
                all += _weights[i];
                if (_x[i] >= x) since += _weights[i];
            }
            return since / all;
        }

        double Growth()
        {
            var x = _x[Math.Min(BlocksAtLeast, Count) - 1];
            return x == 0 ? AgeGrowth : Math.Min(AgeGrowth, _scale / (x * x));
        }

        static double Square(double value) => value * value;
    }
}
