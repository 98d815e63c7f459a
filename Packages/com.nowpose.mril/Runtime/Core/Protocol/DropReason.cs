namespace Nowpose.Protocol
{
    /// <summary>Why a message or a sample was dropped; one for each rule of the protocol.</summary>
    enum DropReason
    {
        /// <summary>Nothing was dropped.</summary>
        None,

        /// <summary>Not one JSON object: syntax, something after it, not text at all.</summary>
        NotJson,

        /// <summary>More bytes of UTF-8 than the topic allows.</summary>
        TooLarge,

        /// <summary>Nested deeper than <see cref="ProtocolLimits.Nesting"/>.</summary>
        TooDeep,

        /// <summary>More fragments than <see cref="ProtocolLimits.FragmentsPerMessage"/>.</summary>
        TooManyFragments,

        /// <summary>Not complete within <see cref="ProtocolLimits.MessageTimeout"/>.</summary>
        TooSlow,

        /// <summary>More messages within a second than the receiver takes from one client.</summary>
        TooManyMessages,

        /// <summary>A field the message needs is not there, or is empty.</summary>
        MissingField,

        /// <summary>A field has another JSON type than the message type says.</summary>
        WrongType,

        /// <summary>A field the message type knows stands there twice.</summary>
        DuplicateField,

        /// <summary>A number outside what its field can hold.</summary>
        OutOfRange,

        UnknownOp,
        UnknownService,

        /// <summary>A publication on a topic the receiver has no use for.</summary>
        UnknownTopic,

        TooManyTopics,

        /// <summary>A position, or another number that must be one, is NaN, infinite or null.</summary>
        NotFinite,

        /// <summary>position or velocity has another length than name.</summary>
        LengthMismatch,

        TooManyJoints,
        NameTooLong,
        DuplicateName,
        StampZero,

        /// <summary>Negative seconds, seconds beyond 32 bits, or nanoseconds that are not 0 to 999 999 999.</summary>
        StampOutOfRange,

        StampInFuture,

        /// <summary>The client's role does not allow it.</summary>
        NotAllowed,

        /// <summary>Another source publishes that joint.</summary>
        JointTaken,

        /// <summary>A slow reader's queue was full: its oldest message.</summary>
        SlowReader,

        /// <summary>A joint already has a sample of that control time.</summary>
        DuplicateSample,

        /// <summary>Older than what a joint's history can still use.</summary>
        LateSample,

        /// <summary>None of the message's joints belongs to the robot.</summary>
        UnknownJoint,

        /// <summary>A robot description that is no URDF, or no robot that can be computed.</summary>
        NotUrdf,

        /// <summary>The headset clock is unsynchronised, so no stamp can be judged.</summary>
        Unsynchronised,
    }
}
