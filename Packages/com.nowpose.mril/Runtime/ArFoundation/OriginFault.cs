namespace Nowpose.ArFoundation
{
    /// <summary>Why a manager on the XR Origin does not work.</summary>
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
