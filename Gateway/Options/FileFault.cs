namespace Nowpose.Gateway.Options;

/// <summary>Reports errors of files and folders that users name as invalid input.</summary>
public static class FileFault
{
    /// <summary>Accesses a file or folder.</summary>
    /// <param name="message">Creates the message for a failure; one line with the path, the reason and the remedy.</param>
    /// <exception cref="InputException">The access failed.</exception>
    public static T Report<T>(Func<T> access, Func<Exception, string> message)
    {
        try
        {
            return access();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException(message(e), e);
        }
    }

    /// <inheritdoc cref="Report{T}"/>
    public static void Report(Action access, Func<Exception, string> message) => Report(
        () =>
        {
            access();
            return true;
        },
        message);

    /// <summary>Whether an access failed because the file or its folder does not exist.</summary>
    public static bool IsMissing(Exception e) => e is FileNotFoundException or DirectoryNotFoundException;
}
