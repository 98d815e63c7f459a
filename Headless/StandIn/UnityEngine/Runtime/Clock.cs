namespace UnityEngine;

/// <summary>Unity's times, in s. They change only from frame to frame.</summary>
sealed class Clock
{
    // Delta time of the first frame, and the maximum of all others, as in Unity.
    const double FirstDelta = 0.02, MaximumDelta = 1f / 3;

    internal int Frame { get; private set; }

    /// <summary>Unscaled time since the start.</summary>
    internal double Real { get; private set; }

    internal double RealDelta { get; private set; }

    /// <summary>Scaled time. Each frame advances it by the real delta time, limited to the maximum delta time.</summary>
    internal double Scaled { get; private set; }

    /// <summary>Starts a frame at the given time, s.</summary>
    internal void Advance(double seconds)
    {
        if (!double.IsFinite(seconds)) throw new ArgumentOutOfRangeException(nameof(seconds), seconds, "the time of a frame must be finite");
        if (Frame > 0 && seconds < Real)
        {
            throw new ArgumentOutOfRangeException(nameof(seconds), seconds, $"time cannot go back: the last frame was at {Real} s");
        }

        var first = Frame == 0;
        RealDelta = first ? FirstDelta : seconds - Real;
        Scaled = first ? seconds : Scaled + Math.Min(RealDelta, MaximumDelta);
        Real = seconds;
        Frame++;
    }
}
