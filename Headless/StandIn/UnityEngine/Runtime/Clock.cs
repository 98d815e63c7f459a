using System;

namespace UnityEngine;

/// <summary>The engine's times, in seconds; they move only from frame to frame.</summary>
sealed class Clock
{
    // What the engine says of a frame that has none before it.
    const double FirstDelta = 0.02;

    internal int Frame { get; private set; }

    /// <summary>Since the start, whatever the scale.</summary>
    internal double Real { get; private set; }

    internal double RealDelta { get; private set; }

    /// <summary>Scaled, and never further than the maximum in one frame.</summary>
    internal double Scaled { get; private set; }

    internal double ScaledDelta { get; private set; }

    internal float Scale { get; set; } = 1;
    internal float MaximumDelta { get; set; } = 1f / 3;

    /// <summary>Begins a frame at the given time.</summary>
    internal void Advance(double seconds)
    {
        if (!double.IsFinite(seconds)) throw new ArgumentOutOfRangeException(nameof(seconds), seconds, "the time of a frame must be finite");
        if (Frame > 0 && seconds < Real)
        {
            throw new ArgumentOutOfRangeException(nameof(seconds), seconds, $"time cannot go back: the last frame was at {Real} s");
        }

        var first = Frame == 0;
        RealDelta = first ? FirstDelta : seconds - Real;
        ScaledDelta = Math.Min(RealDelta, MaximumDelta) * Scale;
        Scaled = first ? seconds : Scaled + ScaledDelta;
        Real = seconds;
        Frame++;
    }
}
