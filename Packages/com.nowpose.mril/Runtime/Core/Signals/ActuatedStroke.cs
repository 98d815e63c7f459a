using System;
using Nowpose.Motion;

namespace Nowpose.Signals
{
    /// <summary>Computes the position of a part that is driven by a signal and has a known stroke time, such as the jaw of a gripper.</summary>
    /// <remarks>
    /// Each change starts a seven-phase move at its stamp, from the position at that time, so a late message does not delay the displayed
    /// part. A move over the whole stroke takes the stroke time; a shorter move has the same acceleration and jerk. A signal between 0 and
    /// 1 gives a position between the ends. With the whole stroke d and its time T: v = 1.5 d/T, a = 6.75 d/T², j = 60.75 d/T³, so that
    /// acceleration, constant velocity and deceleration take T/3 each.
    ///
    /// Values that follow each other within the stroke time, and are not both at an end, are measured positions. They are shown without a move,
    /// because a move that starts again at each value would never gain speed.
    /// </remarks>
    sealed class ActuatedStroke
    {
        /// <summary>Tolerance of values, as a share of the stroke, because the control system may scale and round a measured position.</summary>
        const double Tolerance = 0.01;

        readonly double _atZero;
        readonly double _atOne;
        readonly double _strokeSeconds;
        SevenPhaseProfile _move;
        double _from;
        ControlTime? _start;
        int? _end;

        /// <param name="atZero">Position for the value 0, m or rad.</param>
        /// <param name="atOne">Position for the value 1, m or rad.</param>
        /// <param name="strokeSeconds">Time for the whole stroke, s; 0 if the part jumps to its new position.</param>
        public ActuatedStroke(double atZero, double atOne, double strokeSeconds) =>
            (_atZero, _atOne, _strokeSeconds, _from) = (atZero, atOne, strokeSeconds, atZero);

        /// <summary>Starts the move to a value, or sets the position if the value is a measured position.</summary>
        /// <param name="since">Stamp of the change.</param>
        /// <remarks>The first value after construction or <see cref="Forget"/> sets the position without a move.</remarks>
        public void Change(double value, ControlTime since)
        {
            var seconds = _start.HasValue ? ClockTicks.Seconds(since - _start.Value) : double.PositiveInfinity;
            var end = EndOf(value);
            var isSameEnd = end.HasValue && end == _end;
            // The last digit of the value changes during a move to the end. The move continues.
            if (isSameEnd && seconds < _move.Duration) return;
            var isMeasured = isSameEnd || seconds < _strokeSeconds && !(end.HasValue && _end.HasValue);
            var to = _atZero + Math.Max(0, Math.Min(1, value)) * (_atOne - _atZero);
            _from = isMeasured || !_start.HasValue || _strokeSeconds <= 0 ? to : At(since);
            _move = ProfileOf(to - _from);
            (_start, _end) = (since, end);
        }

        /// <summary>Returns whether a value is within the stroke. Another value moves the part to the nearest end.</summary>
        public static bool Includes(double value) => value >= -Tolerance && value <= 1 + Tolerance;

        /// <summary>Returns the position at a display time.</summary>
        public double At(ControlTime at) => _start.HasValue ? _from + _move.PositionAt(ClockTicks.Seconds(at - _start.Value)) : _from;

        /// <summary>Discards the time of the value, because it is no longer valid. The next value sets the position without a move.</summary>
        public void Forget() => _start = null;

        static int? EndOf(double value) => value <= Tolerance ? 0 : value >= 1 - Tolerance ? 1 : (int?)null;

        SevenPhaseProfile ProfileOf(double distance)
        {
            var stroke = Math.Abs(_atOne - _atZero);
            if (_strokeSeconds <= 0 || stroke == 0) return default;
            var t = _strokeSeconds;
            return new SevenPhaseProfile(distance, 1.5 * stroke / t, 6.75 * stroke / (t * t), 60.75 * stroke / (t * t * t));
        }
    }
}
