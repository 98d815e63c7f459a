using System.Globalization;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Messages;

/// <summary>Messages to clients about a dropped message, with the rule that the message broke and the limit.</summary>
static class DropMessages
{
    public static string Of(DropReason reason) => reason switch
    {
        DropReason.NotJson => "the message is not a text message with a JSON object",
        DropReason.TooLarge =>
            $"the message is longer than {ProtocolLimits.MessageBytes} bytes ({ProtocolLimits.DescriptionBytes} for {RosTopics.RobotDescription})",
        DropReason.TooDeep => $"the message is nested deeper than {ProtocolLimits.Nesting} levels",
        DropReason.TooManyFragments => $"the message has more than {ProtocolLimits.FragmentsPerMessage} fragments",
        DropReason.TooManyMessages => "the client exceeds the message rate of its role",
        DropReason.TooSlow => FormattableString.Invariant($"the message was not complete within {ProtocolLimits.MessageTimeout.TotalSeconds} s"),
        DropReason.MissingField => "a field is missing or empty",
        DropReason.WrongType => "a field or topic has the wrong type",
        DropReason.DuplicateField => "a field occurs twice",
        DropReason.OutOfRange => "a number is outside the allowed range of its field; check the units and values of the message",
        DropReason.UnknownTopic => "clients cannot publish on this topic",
        DropReason.UnknownService => "no such service",
        DropReason.TooManyTopics => $"the client exceeds the maximum of {ProtocolLimits.TopicsPerClient} topics",
        DropReason.NotFinite => "a number is not finite",
        DropReason.LengthMismatch => "the arrays of the message differ in length",
        DropReason.TooManyJoints => $"the message has more than {ProtocolLimits.Joints} joints",
        DropReason.NameTooLong => $"a name is longer than {ProtocolLimits.NameLength} characters",
        DropReason.DuplicateName => "a joint occurs twice",
        DropReason.StampZero => "the stamp is zero",
        DropReason.StampOutOfRange => "the stamp's nanoseconds are outside 0 to 999999999, or its seconds do not fit in 32 bits",
        DropReason.StampInFuture => "the time stamp is later than the control time by more than the clock's error bound plus 1 s",
        DropReason.NotAllowed => "the role of this client does not allow this message",
        DropReason.Unsynchronised => "the clock of its time stamp is not synchronised yet",
        DropReason.JointTaken => "belongs to another source",
        DropReason.NotUnitQuaternion => $"the norm of a rotation differs from 1 by more than {FrameTransform.NormTolerance.ToString(CultureInfo.InvariantCulture)}",
        DropReason.OwnParent => "a frame is its own parent",
        DropReason.WorldAsChild => $"is not possible: {FrameParents.World} is the root of all frames, so it has no parent",
        DropReason.FrameCycle => "is a cycle: its parent depends on the frame itself",
        DropReason.FrameTooDeep => $"is more than {ProtocolLimits.FrameDepth} transforms below the root",
        DropReason.TooManyFrames => $"exceeds the maximum of {ProtocolLimits.Frames} frames",
        DropReason.TooManySignals => $"exceeds the maximum of {ProtocolLimits.Signals} signals",
        DropReason.FrameTaken or DropReason.SignalTaken => "belongs to another source",
        DropReason.InvalidNamespace =>
            "the namespace of a robot must be a letter followed by letters, digits and underscores, with at most "
                + $"{ProtocolLimits.NamespaceLength} characters in all",
        DropReason.TooManyRobots => $"exceeds the maximum of {ProtocolLimits.Robots} robots in namespaces",
        _ => reason.ToString(),
    };
}
