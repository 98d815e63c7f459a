namespace Nowpose.Gateway.Clock;

/// <summary>The control clock C1, the master clock of the control system. May be read from any thread.</summary>
/// <remarks>
/// The time steps back when the master clock does, and by microseconds when the estimate of the master clock is updated. A caller that
/// subtracts two readings must handle a negative result.
/// </remarks>
public interface IControlClock
{
    ControlTime Now { get; }

    /// <summary>Maximum error of the clock against its own reference.</summary>
    TimeSpan ErrorBound => TimeSpan.Zero;

    /// <summary>Whether the clock is synchronised with its own reference.</summary>
    bool IsSynchronised => true;

    /// <summary>Smallest step by which the clock advances; zero when unknown.</summary>
    TimeSpan Resolution => TimeSpan.Zero;

    /// <summary>Rate of the clock relative to this machine's counter, minus one; 1e-6 is 1 ppm.</summary>
    double Skew => 0;
}
