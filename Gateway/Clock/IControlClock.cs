namespace Nowpose.Gateway.Clock;

/// <summary>The control clock C1, the master clock of the control system. May be read from any thread.</summary>
/// <remarks>Goes back where that one does, and by microseconds where it is estimated anew: whoever takes two times in a row minds it.</remarks>
public interface IControlClock
{
    ControlTime Now { get; }

    /// <summary>How wrong the clock itself may be against its own reference.</summary>
    TimeSpan ErrorBound => TimeSpan.Zero;

    /// <summary>Whether the clock follows its own reference.</summary>
    bool IsSynchronised => true;

    /// <summary>The step in which the clock advances; zero when unknown.</summary>
    TimeSpan Resolution => TimeSpan.Zero;

    /// <summary>Its rate over that of this machine's counter, less one; 1e-6 is 1 ppm.</summary>
    double Skew => 0;
}
