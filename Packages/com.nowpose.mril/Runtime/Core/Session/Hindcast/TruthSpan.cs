namespace Nowpose.Session.Hindcast
{
    /// <summary>True position of a joint at one time; <c>default</c> is an unknown position.</summary>
    readonly struct TruthSample
    {
        public TruthSample(ControlTime at, double position)
        {
            IsKnown = true;
            At = at;
            Position = position;
        }

        public bool IsKnown { get; }
        public ControlTime At { get; }
        public double Position { get; }
    }

    /// <summary>
    /// Motion of a joint between two consecutive samples: the cubic through these two samples, the sample before them and the sample after
    /// them.
    /// </summary>
    readonly struct TruthSpan
    {
        readonly double _length, _before;
        readonly double _startPosition, _secant, _bend, _twist, _uncertainty;

        /// <param name="before">Sample before the span; if it is unknown, the curve is a parabola.</param>
        /// <param name="start">Sample at the start of the span.</param>
        /// <param name="end">Sample at the end of the span, later than the start.</param>
        /// <param name="after">
        /// Sample after the span; if it is unknown, the curve is a parabola. If the samples before and after are both unknown, the curve is
        /// a straight line.
        /// </param>
        public TruthSpan(in TruthSample before, in TruthSample start, in TruthSample end, in TruthSample after)
        {
            Start = start.At;
            End = end.At;
            _length = ClockTicks.Seconds(end.At - start.At);
            _before = before.IsKnown ? ClockTicks.Seconds(before.At - start.At) : 0;
            var afterTime = after.IsKnown ? ClockTicks.Seconds(after.At - start.At) : 0;
            _startPosition = start.Position;
            _secant = (end.Position - start.Position) / _length;
            // Newton's divided differences.
            var left = before.IsKnown ? (_secant - (before.Position - start.Position) / _before) / (_length - _before) : 0;
            var right = after.IsKnown ? ((after.Position - end.Position) / (afterTime - _length) - _secant) / afterTime : 0;
            _bend = before.IsKnown ? left : right;
            _twist = before.IsKnown && after.IsKnown ? (right - left) / (afterTime - _before) : 0;
            _uncertainty = before.IsKnown && after.IsKnown ? 0.5 * (right - left) : _bend;
        }

        public ControlTime Start { get; }
        public ControlTime End { get; }

        /// <summary>Returns the position at a given time within the span.</summary>
        /// <param name="uncertainty">
        /// Half the difference between two parabolas through the span: one includes the sample before it, the other the sample after it.
        /// This value is approximately the error of the cubic where the motion has a kink, and larger than its error where the motion is smooth. If
        /// only one of these two samples is known, half the difference is replaced by the difference between the parabola and the straight line.
        /// </param>
        public double At(ControlTime time, out double uncertainty)
        {
            var x = ClockTicks.Seconds(time - Start);
            var inside = x * (x - _length);
            uncertainty = _uncertainty * inside;
            return _startPosition + _secant * x + (_bend + _twist * (x - _before)) * inside;
        }
    }
}
