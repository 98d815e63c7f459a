namespace Nowpose.Network
{
    /// <summary>Where a connection stands.</summary>
    public enum LinkState
    {
        /// <summary>Not asked to connect.</summary>
        Idle,

        Connecting,

        /// <summary>Open, and the other side has answered.</summary>
        Connected,

        /// <summary>Failed or lost; tries again by itself.</summary>
        Waiting,
    }
}
