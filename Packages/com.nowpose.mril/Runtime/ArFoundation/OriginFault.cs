namespace Nowpose.ArFoundation
{
    /// <summary>Reason why a manager on the XR Origin does not work.</summary>
    enum OriginFault
    {
        None,
        NoOrigin,
        NoManager,
        SwitchedOff,
        NotOffered,
        NoSession,
    }
}
