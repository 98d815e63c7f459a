namespace Nowpose.Headless.Tests.Unity;

/// <summary>Moves when the test says so, and by a step with each reading.</summary>
sealed class PlayedClock : IHeadsetClock
{
    HeadsetTime _now;

    /// <summary>What one reading costs: stands for the work that is done between two readings.</summary>
    public TimeSpan Step { get; set; }

    public HeadsetTime Now
    {
        get => _now += Step;
        set => _now = value;
    }
}
