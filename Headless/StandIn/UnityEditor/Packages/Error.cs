namespace UnityEditor.PackageManager;

public class Error
{
    internal Error(string message) => this.message = message;

    public string message { get; }
}
