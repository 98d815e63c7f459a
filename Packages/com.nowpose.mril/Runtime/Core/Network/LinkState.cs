namespace Nowpose.Network
{
    /// <summary>State of a connection.</summary>
    public enum LinkState
    {
        /// <summary>No connection is requested.</summary>
        Idle,

        Connecting,

        /// <summary>The connection is open, and the other side has answered.</summary>
        Connected,

        /// <summary>The connection failed or was lost; it is retried automatically.</summary>
        Waiting,
    }
}
