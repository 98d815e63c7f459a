namespace UnityEditor.PackageManager;

public class Error
{
    internal Error(string message) => this.message = message;

    public string message { get; }
}

public enum StatusCode
{
    InProgress = 0,
    Success = 1,
    Failure = 2,
}
