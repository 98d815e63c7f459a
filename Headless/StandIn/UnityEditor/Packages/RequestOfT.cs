namespace UnityEditor.PackageManager.Requests;

public abstract class Request<T> : Request
{
    internal Request() { }
}
