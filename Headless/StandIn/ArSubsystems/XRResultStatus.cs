namespace UnityEngine.XR.ARSubsystems;

public struct XRResultStatus
{
    readonly bool _isSuccess;

    public XRResultStatus(bool wasSuccessful) => _isSuccess = wasSuccessful;

    public bool IsSuccess() => _isSuccess;
}
