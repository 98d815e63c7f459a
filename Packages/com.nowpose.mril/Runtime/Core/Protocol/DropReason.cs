namespace Nowpose.Protocol
{
    /// <summary>Why a message or a sample was dropped; one reason for each rule of the protocol.</summary>
    enum DropReason
    {
        /// <summary>Nothing was dropped.</summary>
        None,

        /// <summary>Not exactly one JSON object: a syntax error, trailing content, or invalid text.</summary>
        NotJson,

        /// <summary>More bytes of UTF-8 than the topic allows.</summary>
        TooLarge,

        /// <summary>Nested deeper than <see cref="ProtocolLimits.Nesting"/>.</summary>
        TooDeep,

        /// <summary>More fragments than <see cref="ProtocolLimits.FragmentsPerMessage"/>.</summary>
        TooManyFragments,

        /// <summary>Not complete within <see cref="ProtocolLimits.MessageTimeout"/>.</summary>
        TooSlow,

        /// <summary>The client exceeded the rate limit in messages per second.</summary>
        TooManyMessages,

        /// <summary>A required field is missing or empty.</summary>
        MissingField,

        /// <summary>A field has another JSON type than the message type requires.</summary>
        WrongType,

        /// <summary>A field of the message type occurs twice.</summary>
        DuplicateField,

        /// <summary>A number is outside the range of its field.</summary>
        OutOfRange,

        UnknownOp,
        UnknownService,

        /// <summary>A publication on a topic that the receiver does not support.</summary>
        UnknownTopic,

        TooManyTopics,

        /// <summary>A position, or another number that must be finite, is NaN, infinite or null.</summary>
        NotFinite,

        /// <summary>position or velocity differs from name in length.</summary>
        LengthMismatch,

        TooManyJoints,
        NameTooLong,
        DuplicateName,
        StampZero,

        /// <summary>Negative seconds, seconds beyond 32 bits, or nanoseconds outside 0 to 999 999 999.</summary>
        StampOutOfRange,

        StampInFuture,

        /// <summary>The client's role does not allow it.</summary>
        NotAllowed,

        /// <summary>Another source publishes that joint.</summary>
        JointTaken,

        /// <summary>A slow reader's queue was full, so its oldest message was dropped.</summary>
        SlowReader,

        /// <summary>The joint already has a sample of that control time.</summary>
        DuplicateSample,

        /// <summary>The sample is older than the joint's history.</summary>
        LateSample,

        /// <summary>None of the message's joints belongs to the robot.</summary>
        UnknownJoint,

        /// <summary>The robot description is not a URDF, or not a robot that can be computed.</summary>
        NotUrdf,

        /// <summary>The headset clock is unsynchronised, so stamps cannot be checked.</summary>
        Unsynchronised,
    }
}
