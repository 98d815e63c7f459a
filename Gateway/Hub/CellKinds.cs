namespace Nowpose.Gateway.Hub;

/// <summary>Words for the kinds of things that have one source each.</summary>
static class CellKinds
{
    public const string Joint = "joint";
    public const string Frame = "frame";
    public const string Signal = "signal";

    /// <param name="topic">/tf, /tf_static or /signals; any other topic is a topic of joints.</param>
    public static string Of(string topic) => topic switch
    {
        RosTopics.Signals => Signal,
        RosTopics.Tf or RosTopics.TfStatic => Frame,
        _ => Joint,
    };

    /// <summary>Whether a topic is latched per name: new subscribers receive the newest value of each frame or signal.</summary>
    public static bool IsLatched(string topic) => topic is RosTopics.TfStatic or RosTopics.Signals;
}
