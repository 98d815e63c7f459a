using Nowpose.Prediction.Samples;

namespace Nowpose.Cli.Replay;

/// <summary>Consecutive samples of one source, without a step of the clock or a restart of the source between them.</summary>
abstract class SampleRun(int timeLine)
{
    ControlTime? _newest;

    public int TimeLine => timeLine;

    /// <summary>Whether the next sample belongs to this run. If its time stamp is far behind, the clock of the source went back.</summary>
    public bool Includes(int ofTimeLine, ControlTime at) => ofTimeLine == timeLine && !(_newest is { } newest && ArrivalLimits.IsFarBehind(at, newest));

    protected void Extend(ControlTime at)
    {
        if (!(at <= _newest)) _newest = at;
    }
}
