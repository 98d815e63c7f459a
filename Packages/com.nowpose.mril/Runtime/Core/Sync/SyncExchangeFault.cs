namespace Nowpose.Sync
{
    /// <summary>Reason why a sync exchange was dropped or set aside.</summary>
    enum SyncExchangeFault
    {
        None,

        /// <summary>The reply and the request have different sequence numbers.</summary>
        WrongSequence,

        /// <summary>The echoed t1 differs from the t1 of the request.</summary>
        WrongEcho,

        /// <summary>t3 is before t2: the server sent the reply before it received the request.</summary>
        ControlTimeReversed,

        /// <summary>t4 is before t1: the headset received the reply before it sent the request.</summary>
        HeadsetTimeReversed,

        /// <summary>The server's processing time exceeds the duration of the exchange by more than the resolution of its clock.</summary>
        NegativeRoundTrip,

        /// <summary>A time stamp is more than 146 years from its epoch. It is implausible, and sums with it would overflow.</summary>
        ImplausibleTime,

        /// <summary>The data is not a protocol frame: wrong magic, version or kind. Ends the connection.</summary>
        NotAFrame,

        /// <summary>
        /// The exchange contradicts recent exchanges: a possible step or correction of a clock, or an inconsistent server. It is set aside.
        /// </summary>
        Contradiction,

        /// <summary>t4 is not after the t4 of the previous exchange. In a log, lines are out of order or repeated.</summary>
        NotNewer,
    }
}
