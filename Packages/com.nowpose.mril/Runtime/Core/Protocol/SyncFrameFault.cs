namespace Nowpose.Protocol
{
    /// <summary>Why bytes are not a sync frame. Each fault closes the connection.</summary>
    enum SyncFrameFault
    {
        None,
        WrongSize,
        WrongMagic,
        WrongVersion,
        WrongKind,
    }
}
