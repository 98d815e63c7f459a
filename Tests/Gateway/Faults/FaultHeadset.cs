using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Runs the headset's runtime without a display, and observes it during a fault.</summary>
sealed class FaultHeadset : IDisposable
{
    static readonly TimeSpan ClockTolerance = TimeSpan.FromMilliseconds(40);

    readonly StopwatchHeadsetClock _clock = new();

    public FaultHeadset(int syncPort, int webSocketPort, CertificatePin pin = null, string token = null)
    {
        Session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", syncPort, webSocketPort, pin, token: token), VisualisationLatency.FromMilliseconds(40)),
            RobotFiles.Load("youbot"), _clock);
        Session.Connect();
    }

    public CompensationSession Session { get; }

    public PoseState State => Session.Tick(_clock.Now).State;

    public bool IsConnected => AreLinks(LinkState.Connected);

    public string Links => Session.SyncLink + " | " + Session.SampleLink;

    /// <returns>Time until the headset was in this state.</returns>
    public Task<TimeSpan> BecomesAsync(PoseState state) => BecomesAsync(() => State == state, state.ToString());

    /// <returns>Time until the condition was fulfilled.</returns>
    public Task<TimeSpan> BecomesAsync(Func<bool> condition, string what) => Soon.BecomesAsync(condition, () => $"{what}: {State}, {Links}");

    /// <summary>Whether the error of the headset's estimate of the control clock is less than half of the smallest step in these tests.</summary>
    public bool IsClockCorrect(IControlClock control)
    {
        _ = State;
        var model = Session.Clock.ModelAt(_clock.Now);
        if (model.State != ClockState.Synchronised) return false;
        var (headset, truth) = (_clock.Now, control.Now);
        return (model.ToControl(headset) - truth).Duration() < ClockTolerance;
    }

    public void Dispose() => Session.Dispose();

    bool AreLinks(LinkState state)
    {
        _ = State;
        return Session.SyncLink.State == state && Session.SampleLink.State == state;
    }
}
