namespace UnityEditor.PackageManager.Requests;

public abstract class Request : ISerializationCallbackReceiver
{
    internal Request() { }

    public StatusCode Status { get; private set; }
    public bool IsCompleted => Status != StatusCode.InProgress;
    public Error Error { get; private set; }

    void ISerializationCallbackReceiver.OnBeforeSerialize() { }

    void ISerializationCallbackReceiver.OnAfterDeserialize() { }

    internal void Succeed() => Status = StatusCode.Success;

    internal void Fail(string message)
    {
        Status = StatusCode.Failure;
        Error = new Error(message);
    }
}

public abstract class Request<T> : Request
{
    internal Request() { }
}

public sealed class AddRequest : Request<PackageInfo>
{
    internal AddRequest() { }
}
