namespace Nowpose.Gateway.Options;

/// <summary>Reports errors of files and folders that users name as invalid input, except failures of the disk.</summary>
public static class FileFault
{
    /// <summary>Error numbers of Unix for a failure of the device, a too large file, a full disk and an exceeded quota (Linux, macOS).</summary>
    static readonly int[] DiskErrors = [5, 27, 28, 122, 69];

    /// <summary>Error codes of Windows for a full disk, and for a failure of the device.</summary>
    static readonly int[] WindowsDiskErrors = [unchecked((int)0x80070070), unchecked((int)0x80070027), unchecked((int)0x8007045d)];

    /// <summary>Error numbers of Linux and macOS, and error code of Windows, for a file that another process has opened.</summary>
    static readonly int[] SharingErrors = [11, 35, unchecked((int)0x80070020)];

    /// <summary>Accesses a file or folder.</summary>
    /// <param name="message">Creates the message for a failure; one line with the path, the reason and the remedy.</param>
    /// <exception cref="InputException">The access failed.</exception>
    /// <exception cref="IOException">The disk is full or failed.</exception>
    public static T Report<T>(Func<T> access, Func<Exception, string> message)
    {
        try
        {
            return access();
        }
        // The access itself has reported the failure, with the path.
        catch (Exception e) when (e is IOException or InputException && IsOfDisk(e.InnerException))
        {
            throw new IOException(e.Message, e.InnerException);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw IsOfDisk(e) ? new IOException(message(e), e) : new InputException(message(e), e);
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

    static bool IsOfDisk(Exception e) => e is IOException && (OperatingSystem.IsWindows() ? WindowsDiskErrors : DiskErrors).Contains(e.HResult);

    /// <summary>Whether an access failed because another process has opened the file.</summary>
    public static bool IsInUse(Exception e) => e is IOException && SharingErrors.Contains(e.HResult);

    /// <summary>Whether an access failed because the file or its folder does not exist.</summary>
    public static bool IsMissing(Exception e) => e is FileNotFoundException or DirectoryNotFoundException;
}
