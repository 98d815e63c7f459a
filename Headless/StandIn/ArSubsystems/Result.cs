namespace UnityEngine.XR.ARSubsystems;

/// <summary>Result of an asynchronous request, since AR Foundation 6.</summary>
public struct Result<T>
{
    public Result(XRResultStatus status, T value)
    {
        this.status = status;
        this.value = value;
    }

    public XRResultStatus status { get; }
    public T value { get; }
}
