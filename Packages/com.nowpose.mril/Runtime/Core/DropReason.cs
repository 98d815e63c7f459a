namespace Nowpose
{
    /// <summary>
    /// Reason why a message or a sample was dropped. Each rule of the protocol has its own reason. Parser, gateway, predictor and statistics use
    /// the same reasons.
    /// </summary>
    public enum DropReason
    {
        /// <summary>
        /// Nothing was dropped. This value also applies to a sample that newer samples have overtaken, because it is used together with the next
        /// sample, to a sample that thinning leaves out, and to the pose of a frame that is not shown, because it is kept.
        /// </summary>
        None,

        /// <summary>The message is not exactly one JSON object: it has a syntax error, trailing content, or invalid text.</summary>
        NotJson,

        /// <summary>The message has more bytes of UTF-8 than the topic allows.</summary>
        TooLarge,

        /// <summary>The message is nested more deeply than the protocol allows.</summary>
        TooDeep,

        /// <summary>The message has more fragments than the protocol allows.</summary>
        TooManyFragments,

        /// <summary>The message was not complete within the protocol's timeout.</summary>
        TooSlow,

        /// <summary>The client exceeded the rate limit in messages per second.</summary>
        TooManyMessages,

        /// <summary>A required field is missing or empty.</summary>
        MissingField,

        /// <summary>A field does not have the JSON type that the message requires.</summary>
        WrongType,

        /// <summary>A field of the message type occurs twice.</summary>
        DuplicateField,

        /// <summary>A number is outside the range of its field.</summary>
        OutOfRange,

        UnknownOp,
        UnknownService,

        /// <summary>The message was published on a topic that the receiver does not support.</summary>
        UnknownTopic,

        TooManyTopics,

        /// <summary>A position, or another number that must be finite, is NaN, infinite or null.</summary>
        NotFinite,

        /// <summary>The array "position" or "velocity" does not have the same length as the array "name".</summary>
        LengthMismatch,

        TooManyJoints,
        NameTooLong,
        DuplicateName,
        StampZero,

        /// <summary>The stamp has negative seconds, seconds beyond 32 bits, or nanoseconds outside 0 to 999 999 999.</summary>
        StampOutOfRange,

        StampInFuture,

        /// <summary>The client's role does not allow the message.</summary>
        NotAllowed,

        /// <summary>Another source already publishes the joint.</summary>
        JointTaken,

        /// <summary>The queue of a slow reader was full, so the oldest message in the queue was dropped.</summary>
        SlowReader,

        /// <summary>The joint already has a sample with the same control time, within 1 µs.</summary>
        DuplicateSample,

        /// <summary>
        /// The sample is older than all samples that the prediction uses, or it is late and its position contradicts the samples before and after it.
        /// </summary>
        LateSample,

        /// <summary>None of the message's joints belongs to the robot.</summary>
        UnknownJoint,

        /// <summary>The robot description is not a URDF, or the kinematics of the described robot cannot be computed.</summary>
        NotUrdf,

        /// <summary>The headset clock is unsynchronised, so stamps cannot be checked.</summary>
        Unsynchronised,

        /// <summary>The norm of a rotation is not 1.</summary>
        NotUnitQuaternion,

        /// <summary>A frame is named as its own parent.</summary>
        OwnParent,

        /// <summary>The world is named as a child; it is the root of all frames.</summary>
        WorldAsChild,

        /// <summary>The parent of a frame depends on the frame itself.</summary>
        FrameCycle,

        /// <summary>There are more transforms from a frame to its root than the protocol allows.</summary>
        FrameTooDeep,

        /// <summary>There are more frames in one message or in the cell than the protocol allows.</summary>
        TooManyFrames,

        /// <summary>There are more signals in one message or in the cell than the protocol allows.</summary>
        TooManySignals,

        /// <summary>Another source already publishes the frame.</summary>
        FrameTaken,

        /// <summary>Another source already publishes the signal.</summary>
        SignalTaken,

        /// <summary>The namespace of a robot's topic is not a valid name.</summary>
        InvalidNamespace,

        /// <summary>There are more robots in namespaces than the protocol allows.</summary>
        TooManyRobots,
    }
}
