using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>A path and when it begins; <c>default</c> is none.</summary>
    readonly struct ActivePlan
    {
        readonly PlannedPath _path;
        readonly double _start;
        readonly double _from;

        /// <param name="start">The plan's stamp, s.</param>
        /// <param name="from">
        /// Where the joint is then: a plan whose first set-point comes later leads there from wherever the joint is.
        /// </param>
        public ActivePlan(PlannedPath path, double start, double from)
        {
            _path = path;
            _start = start;
            _from = from;
        }

        public bool IsNone => _path == null;

        /// <summary>s.</summary>
        public double Start => _start;

        /// <summary>s.</summary>
        public double End => _start + _path.Last;

        public double Range => _path.Range + Math.Abs(_from - _path.FirstPosition);

        public bool EndsAtRest => _path.EndsAtRest;

        /// <summary>Position at a time; before the start and after the end, the one there.</summary>
        public double At(double time, out double velocity)
        {
            var x = time - _start;
            if (_path.First <= 0 || x >= _path.First) return _path.At(x, out velocity);
            var way = _path.FirstPosition - _from;
            velocity = x < 0 ? 0 : way / _path.First;
            return _from + way * Math.Max(x, 0) / _path.First;
        }
    }
}
