namespace UnityEngine.XR.ARSubsystems;

/// <summary>Result of an asynchronous request, since AR Foundation 6.</summary>
public struct Result<T>(XRResultStatus status, T value)
{
    public XRResultStatus status { get; } = status;
    public T value { get; } = value;
}

public struct XRResultStatus
{
    readonly bool _isSuccess;

    public XRResultStatus(bool wasSuccessful) => _isSuccess = wasSuccessful;

    public bool IsSuccess() => _isSuccess;
}
