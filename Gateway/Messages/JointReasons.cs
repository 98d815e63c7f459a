namespace Nowpose.Gateway.Messages;

/// <summary>Reasons for the state of a joint.</summary>
static class JointReasons
{
    public static string Taken(string source) => $"the source {source} already publishes this joint; stop one of the two sources";

    public const string NoSample = "the adapter reports the joint as live, but no sample has arrived at the gateway";
    public const string NoSampleAtRest = "the adapter reports the joint at rest, but no sample has arrived at the gateway";
    public const string NoReport = "the adapter stopped reporting before the first sample";

    public static string Silent(string adapter) => $"samples stopped arriving, and the adapter {adapter} has stopped reporting";

    public const string SamplesStopped = "samples stopped arriving, although the adapter reports the joint as live";
    public const string StampsStopped = "its samples arrive with an unchanged time stamp; set each stamp to the control time of its sample";
    public const string StampsOld = "its samples arrive with time stamps that are more than 10 s old; compare the clock of its source with the control clock";
    public const string NotPublished = "the robot description has this joint, but no source publishes it";
    public const string NoSource = "no source publishes joint positions yet";

    public static string Summary(string live, int resting) => $"{live} live, {resting} assumed at rest";
}
