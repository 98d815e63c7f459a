using Nowpose.Messages;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Messages;

/// <summary>Messages to clients about a dropped message, with the rule that the message broke and the limit.</summary>
static class DropMessages
{
    static readonly string OpenTopics = string.Join(
        ", ", RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.RobotDescription, RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals,
        RosTopics.Diagnostics, RosTopics.Displayed);

    /// <summary>Precedes the text of <see cref="DropReason.TooLarge"/> if the limit applies to the message that the gateway would send.</summary>
    public const string AsWritten = "as the gateway writes it,";

    public static readonly string TooManySubscriptions =
        $"the client exceeds the maximum of {ProtocolLimits.SubscriptionsPerTopic} subscriptions to one topic; unsubscribe from some, or use their ids again";

    public static readonly string IdTooLong = $"the id is longer than the maximum of {ProtocolLimits.KeyLength} characters; shorten it";

    /// <summary>Precedes the fault of a description.</summary>
    public const string KeptDescription = "the robot keeps its earlier description; correct this one, which is invalid:";

    /// <param name="fault">The fault of a description that is published nevertheless.</param>
    public static string InvalidDescription(string fault) => $"has an invalid description: {fault}; correct it, so that headsets can show the robot";

    public const string NotOneStatus = "the message must have exactly one status";

    public static readonly string ClockTaken =
        $"the clock {Of(DropReason.JointTaken)}; set another plant.name, or stop one of the two sources if it is not a standby";

    public static string ReservedClock(string name) =>
        $"the clock {name} is reserved for the adapter that the gateway starts for its plant (--plant); set another plant.name";

    public static string TooManyClocks(int max) => $"the gateway already has {max} clocks, which is the maximum; stop clients that are not needed";

    /// <param name="clock">The clock of the time stamp and its rate, as a clause.</param>
    public static string ClockRate(string clock) =>
        $"{clock}, and its times cannot be converted; correct time.unit in the plant's file, or stamp with a clock in real time";

    /// <param name="max">Maximum number of joints on a topic, of all sources.</param>
    public static string TooManyNames(int max) =>
        $"exceeds the maximum of {max} different joints of all messages; unadvertise the topic, or connect again, to release the earlier joints";

    /// <param name="max">Maximum number of joints on a topic, of one source.</param>
    public static string TooManyNamesOfSource(int max) =>
        $"exceeds the maximum of {max} different joints of all messages of one source; unadvertise the topic, or connect again, to release the "
        + "earlier joints";

    /// <param name="topic">Topic of the other joint.</param>
    /// <param name="joint">Name of the other joint on its topic.</param>
    public static string SameCellName(string topic, string joint) =>
        $"has the same cell-wide name as the joint {joint} on {topic}, which belongs to another robot; rename one of the two joints, "
        + "or restart the gateway if the other robot is no longer used";

    /// <param name="maxPerSecond">Maximum number of messages that the client's role may send per second.</param>
    public static string TooManyMessages(int maxPerSecond) =>
        $"the client exceeds the message rate of its role; the maximum is {maxPerSecond} messages/s; reduce the rate";

    public static string Of(DropReason reason) => reason switch
    {
        DropReason.NotJson => "the message must be a text message with one JSON object",
        DropReason.TooLarge =>
            $"the message is longer than the maximum of {ProtocolLimits.MessageBytes} bytes ({ProtocolLimits.DescriptionBytes} bytes for "
                + $"{RosTopics.RobotDescription})",
        DropReason.TooDeep => $"the message is nested deeper than the maximum of {ProtocolLimits.Nesting} levels",
        DropReason.TooManyFragments => $"the message has more than the maximum of {ProtocolLimits.FragmentsPerMessage} fragments",
        DropReason.TooSlow => FormattableString.Invariant(
            $"the message was not complete within the maximum of {ProtocolLimits.MessageTimeout.TotalSeconds} s"),
        DropReason.MissingField => "a field is missing or empty; write a value in each field that the operation or the message type requires",
        DropReason.WrongType => "a field or topic has the wrong type; use the types of the topic's message type",
        DropReason.DuplicateField => "a field occurs twice; remove one",
        DropReason.OutOfRange => "a number is outside the allowed range of its field; check the units and values of the message",
        DropReason.UnknownTopic => "clients cannot publish on this topic; allowed: " + OpenTopics,
        DropReason.UnknownService => $"no such service; see /rosapi/services for a list. A clock must be offered as {RosTopics.PlantTime}NAME",
        DropReason.TooManyTopics => $"the client exceeds the maximum of {ProtocolLimits.TopicsPerClient} topics; unsubscribe from some, or unadvertise some",
        DropReason.NotFinite => "a number is not finite; use finite numbers only",
        DropReason.LengthMismatch => "the arrays of the message differ in length; each must have one value for each name",
        DropReason.TooManyJoints => $"the message has more than the maximum of {ProtocolLimits.Joints} joints",
        DropReason.NameTooLong =>
            $"a name is longer than the maximum of {ProtocolLimits.NameLength} characters ({ProtocolLimits.KeyLength} for a key of the diagnostics); "
                + "an emoji counts as two characters",
        DropReason.DuplicateName => "a name occurs twice; remove one",
        DropReason.StampZero => "the stamp is zero; set it to the control time of the sample",
        DropReason.StampOutOfRange => "a time is out of range; allowed: seconds that fit in 32 bits, and 0 to 999999999 ns",
        DropReason.StampInFuture =>
            "the time stamp is later than the control time by more than the clock's error bound plus 1 s; set the clock of the source",
        DropReason.NotAllowed =>
            "the role of this client does not allow this message; use the token of a source; without tokens, connect to localhost on the gateway's "
                + "machine",
        DropReason.Unsynchronised => "the clock of its time stamp is not synchronised yet; wait",
        DropReason.JointTaken => "belongs to another source",
        DropReason.NotUnitQuaternion => FormattableString.Invariant(
            $"the norm of a rotation differs from 1 by more than the maximum of {FrameTransform.NormTolerance}; normalise the quaternion"),
        DropReason.OwnParent => FrameMessages.OwnParent,
        DropReason.WorldAsChild => $"is not possible: {FrameParents.World} is the root of all frames, so it has no parent; rename the child frame",
        DropReason.FrameCycle => "is a cycle: its parent depends on the frame itself; correct its header.frame_id",
        DropReason.FrameTooDeep => $"is more than {ProtocolLimits.FrameDepth} transforms below the root; reduce the depth",
        DropReason.TooManyFrames => $"exceeds the maximum of {ProtocolLimits.Frames} frames",
        DropReason.TooManySignals => $"exceeds the maximum of {ProtocolLimits.Signals} signals",
        DropReason.FrameTaken or DropReason.SignalTaken => "belongs to another source",
        DropReason.InvalidNamespace =>
            "the namespace of a robot must be a letter followed by letters, digits and underscores, with at most "
                + $"{ProtocolLimits.NamespaceLength} characters in all",
        DropReason.TooManyRobots => $"exceeds the maximum of {ProtocolLimits.Robots} robots in namespaces",
        // See TooManyMessages for a client that exceeds its rate.
        _ => reason.ToString(),
    };
}
