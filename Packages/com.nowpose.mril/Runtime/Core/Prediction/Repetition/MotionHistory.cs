using System;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>Two minutes of a joint's motion on a uniform time grid, interpolated from samples at any intervals.</summary>
    /// <remarks>
    /// Indices count grid points since the start and never wrap. The grid ends one sample before the newest, so that every
    /// point has samples on both sides. Allocates nothing after construction.
    /// </remarks>
    sealed class MotionHistory
    {
        /// <summary>Points kept: two minutes at 20 ms.</summary>
        public const int Capacity = 6000;

        /// <summary>The next power of two: index operations use a mask instead of thousands of divisions per sample.</summary>
        const int RingSize = 8192;

        /// <summary>Samples around a grid point: two on either side determine a cubic.</summary>
        const int Neighbours = 4;

        /// <summary>Threshold of a spike: displacement there and back, relative to the maximum displacement in one direction.</summary>
        const double SpikeRatio = 1.3;

        /// <summary>Distance from a grid point, in steps, within which a sample counts as lying on it.</summary>
        const double Rounding = 1e-6;

        readonly double[] _points = new double[RingSize];
        readonly double[] _times = new double[Neighbours];
        readonly double[] _positions = new double[Neighbours];
        int _samples;
        double _maxDisplacement;
        double _start;

        /// <summary>Grid step, s.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Index of the oldest point kept.</summary>
        public long First => Math.Max(0, Count - Capacity);

        /// <summary>Position at a grid point between <see cref="First"/> and the last.</summary>
        public double this[long index] => _points[index & (RingSize - 1)];

        /// <summary>Adds to each lag's sum the squared difference of the grid points that are that lag apart.</summary>
        /// <param name="index">Index of the later grid point.</param>
        /// <param name="keeping">Forgetting factor of the sums, 0 to 1.</param>
        public void AddSquaredDifferences(long index, int minLag, int maxLag, int step, double keeping, double[] sums)
        {
            var points = _points;
            var now = this[index];
            var longest = (int)Math.Min(index, maxLag);
            for (var lag = minLag; lag <= longest; lag += step)
            {
                var difference = now - points[(int)(index - lag) & (RingSize - 1)];
                sums[lag] = keeping * sums[lag] + difference * difference;
            }
        }

        /// <summary>Clears the history and sets the grid step.</summary>
        /// <param name="step">Grid step in s.</param>
        public void Start(double step)
        {
            Step = step;
            Count = 0;
            _samples = 0;
            _maxDisplacement = 0;
        }

        /// <summary>Adds a sample newer than all before.</summary>
        public void Add(double time, double position)
        {
            if (_samples == 0) _start = time;
            else if (!(time > _times[0])) return;
            for (var i = Neighbours - 1; i > 0; i--)
            {
                _times[i] = _times[i - 1];
                _positions[i] = _positions[i - 1];
            }
            _times[0] = time;
            _positions[0] = position;
            if (_samples < Neighbours)
            {
                // Until there are enough samples, the first one is repeated backwards in time.
                for (var i = _samples + 1; i < Neighbours; i++)
                {
                    _times[i] = _times[i - 1] - Step;
                    _positions[i] = _positions[i - 1];
                }
                _samples++;
            }
            if (_samples == Neighbours) TakeOutSpike();
            for (; TimeOf(Count) <= _times[1] + Rounding * Step; Count++) _points[Count & (RingSize - 1)] = Between(TimeOf(Count));
        }

        // A wrong sample would reappear in a forecast whenever the motion repeats.
        void TakeOutSpike()
        {
            double to = _positions[1] - _positions[2], from = _positions[0] - _positions[1];
            var less = Math.Min(Math.Abs(to), Math.Abs(from));
            if (to * from >= 0) _maxDisplacement = Math.Max(_maxDisplacement, less);
            else if (_maxDisplacement > 0 && less > SpikeRatio * _maxDisplacement)
                _positions[1] = _positions[2] + (_positions[0] - _positions[2]) * (_times[1] - _times[2]) / (_times[0] - _times[2]);
        }

        /// <summary>Converts a time to a fractional grid index.</summary>
        public double IndexOf(double time) => (time - _start) / Step;

        /// <summary>Returns the position at a fractional index by a Catmull-Rom spline; it needs two points on either side.</summary>
        /// <param name="speed">Change per grid step there.</param>
        public double At(double index, out double speed)
        {
            var i = (long)Math.Floor(index);
            var f = index - i;
            double p0 = this[i - 1], p1 = this[i], p2 = this[i + 1], p3 = this[i + 2];
            var a = p2 - p0;
            var b = 2 * p0 - 5 * p1 + 4 * p2 - p3;
            var c = 3 * (p1 - p2) + p3 - p0;
            speed = 0.5 * (a + f * (2 * b + 3 * f * c));
            return p1 + 0.5 * f * (a + f * (b + f * c));
        }

        /// <summary>Returns whether <see cref="At"/> has a position for an index.</summary>
        public bool Covers(double index) => index >= First + 1 && index < Count - 2;

        double TimeOf(long index) => _start + index * Step;

        // Cubic Hermite between samples 2 and 1, with slopes of the parabolas through their neighbours.
        double Between(double time)
        {
            double h0 = _times[2] - _times[3], h1 = _times[1] - _times[2], h2 = _times[0] - _times[1];
            double d0 = (_positions[2] - _positions[3]) / h0, d1 = (_positions[1] - _positions[2]) / h1, d2 = (_positions[0] - _positions[1]) / h2;
            var m1 = (d0 * h1 + d1 * h0) / (h0 + h1);
            var m2 = (d1 * h2 + d2 * h1) / (h1 + h2);
            var x = time - _times[2];
            var c = (3 * d1 - 2 * m1 - m2) / h1;
            var d = (m1 + m2 - 2 * d1) / (h1 * h1);
            return _positions[2] + x * (m1 + x * (c + x * d));
        }
    }
}
