namespace Nowpose.Protocol
{
    /// <summary>Why bytes are not a sync frame. Any of them closes the connection.</summary>
    enum SyncFrameFault
    {
        None,
        WrongSize,
        WrongMagic,
        WrongVersion,
        WrongKind,
    }
}
