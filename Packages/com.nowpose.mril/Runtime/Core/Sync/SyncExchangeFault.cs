namespace Nowpose.Sync
{
    /// <summary>Why a sync exchange was dropped.</summary>
    enum SyncExchangeFault
    {
        None,

        /// <summary>The reply's sequence number is not the request's.</summary>
        WrongSequence,

        /// <summary>The echoed t1 is not the request's.</summary>
        WrongEcho,

        /// <summary>t3 before t2: the server sent before it received.</summary>
        ControlTimeReversed,

        /// <summary>t4 before t1: the headset received before it sent.</summary>
        HeadsetTimeReversed,

        /// <summary>The server kept the request for longer than the whole exchange took, by more than its clock's resolution.</summary>
        NegativeRoundTrip,

        /// <summary>A timestamp beyond ±146 years of its epoch: no clock shows it, and sums with it would overflow.</summary>
        ImplausibleTime,

        /// <summary>Not a frame of the protocol: wrong magic, version or kind. Ends the connection.</summary>
        NotAFrame,

        /// <summary>Contradicts the recent exchanges: the first signs of a clock step, or a server that is not of one mind. Set aside.</summary>
        Contradiction,

        /// <summary>t4 is not after the previous exchange's: a log out of order, or a repeated line.</summary>
        NotNewer,
    }
}
