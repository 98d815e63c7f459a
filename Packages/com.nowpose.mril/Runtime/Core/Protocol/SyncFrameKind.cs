namespace Nowpose.Protocol
{
    /// <summary>Kind of a sync frame; the values are those on the wire.</summary>
    enum SyncFrameKind : byte
    {
        /// <summary>t1 from the headset.</summary>
        Request = 1,

        /// <summary>t1 echoed, with t2 and t3.</summary>
        Reply = 2,

        /// <summary>Announces a token, which follows the frame (<see cref="SyncToken"/>).</summary>
        Token = 0x10,

        /// <summary>Reports whether the token was accepted.</summary>
        TokenReply = 0x11,
    }
}
