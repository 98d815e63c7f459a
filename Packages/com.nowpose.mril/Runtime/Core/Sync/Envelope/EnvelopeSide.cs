using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// One side of the corridor in which the offset lies: the tightest bound of each block of exchanges, and how much each
    /// of them is worth.
    /// </summary>
    /// <remarks>
    /// A packet can only be late, so what is wrong with a bound is wrong to one side. A late one gets the weight
    /// 1/(s² + e² + a²): e is how far it falls behind the blocks' upper quartile, s how far they usually do, a what the rates
    /// of the clocks may have made of it since.
    /// </remarks>
    sealed class EnvelopeSide
    {
        /// <summary>What counts as punctual among the blocks; of the punctual bounds, the scale is what this share does not exceed.</summary>
        const double PunctualShare = 0.75, ScaleShare = 0.4;

        /// <summary>Smallest scale, s: without it a few equal stamps would count for all others.</summary>
        const double LeastScale = 3e-6;

        /// <summary>Scale of bounds that leave a part of a coarse clock's step unmet, in lengths of that part: half of it is too small.</summary>
        const double UnmetShare = 0.1;

        /// <summary>a = this · age², 1/s: as if the skew changed by 2 ppm within 50 s in a way that no slope and bend can follow.</summary>
        const double AgeGrowth = 2e-8;

        /// <summary>So many blocks count in full whatever their age: a scale that got too small would leave too few to measure it by.</summary>
        const int BlocksAtLeast = 8;

        /// <summary>
        /// Power of the number of blocks by which the scatter of round trips is divided for what their scale hides at least: few bounds
        /// agree by chance, and a line through three late packets can be steep.
        /// </summary>
        const double YouthPower = 1.5;

        readonly int _sign;
        readonly double[] _x, _y, _behind, _recency, _weights;
        readonly WeightedQuantile _quantile;
        double _scale;

        /// <param name="sign">1 where bounds lie below the offset, −1 where they lie above.</param>
        /// <param name="mostBlocks">Blocks at most.</param>
        public EnvelopeSide(int sign, int mostBlocks)
        {
            _sign = sign;
            _x = new double[mostBlocks];
            _y = new double[mostBlocks];
            _behind = new double[mostBlocks];
            _recency = new double[mostBlocks];
            _weights = new double[mostBlocks];
            _quantile = new WeightedQuantile(mostBlocks);
        }

        public int Count { get; private set; }

        /// <summary>Seconds since the reference.</summary>
        public double X(int block) => _x[block];

        /// <summary>Seconds above the reference offset.</summary>
        public double Y(int block) => _y[block];

        /// <summary>1/s².</summary>
        public double Weight(int block) => _weights[block];

        public void Clear()
        {
            Count = 0;
            // None yet: at first all blocks count alike, however old.
            _scale = double.PositiveInfinity;
        }

        /// <summary>Begins a block with its first bound.</summary>
        public void Begin(double x, double y)
        {
            _x[Count] = x;
            _y[Count] = y;
            Count++;
        }

        /// <summary>A further bound of the block, which stays the block's if it is the tightest.</summary>
        public void Improve(double x, double y, OffsetCurve curve)
        {
            var last = Count - 1;
            if (_sign * (y - curve.At(x)) <= _sign * (_y[last] - curve.At(_x[last]))) return;
            _x[last] = x;
            _y[last] = y;
        }

        /// <summary>Weighs the blocks by a curve, which knows the height of neither side.</summary>
        /// <param name="scatter">As of <see cref="EnvelopeFit.Solve"/>, s.</param>
        /// <param name="unmet">As of <see cref="UnmetPart"/>, s.</param>
        public void Weigh(OffsetCurve curve, double scatter, double unmet)
        {
            var growth = Growth();
            for (var i = 0; i < Count; i++)
            {
                _behind[i] = _sign * (_y[i] - curve.At(_x[i]));
                _recency[i] = double.IsInfinity(_scale) ? 1 : 1 / (1 + Square(growth * _x[i] * _x[i] / _scale));
            }
            var punctual = _quantile.Of(_behind, _recency, Count, PunctualShare);
            for (var i = 0; i < Count; i++) _behind[i] = Math.Max(0, punctual - _behind[i]);
            _scale = _quantile.Of(_behind, _recency, Count, ScaleShare) + LeastScale + UnmetShare * unmet
                + scatter / Math.Pow(Count, YouthPower);

            growth = Growth();
            for (var i = 0; i < Count; i++)
                _weights[i] = 1 / (_scale * _scale + _behind[i] * _behind[i] + Square(growth * _x[i] * _x[i]));
        }

        double Growth()
        {
            var x = _x[Math.Min(BlocksAtLeast, Count) - 1];
            return x == 0 ? AgeGrowth : Math.Min(AgeGrowth, _scale / (x * x));
        }

        static double Square(double value) => value * value;
    }
}
