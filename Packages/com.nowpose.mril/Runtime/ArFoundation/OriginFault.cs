namespace Nowpose.ArFoundation
{
    /// <summary>Reason why an AR Foundation manager on the XR Origin does not work.</summary>
    enum OriginFault
    {
        None,
        NoOrigin,
        NoManager,
        SwitchedOff,
        NotOffered,
        NoSession,
        NotRunning,
    }
}
