using System.ComponentModel;
using System.Diagnostics;
using System.Text;
using Nowpose.Web.Messages;

namespace Nowpose.Web;

/// <summary>Starts scripts with Node.js.</summary>
public static class NodeProgram
{
    /// <summary>Returns the path of the Node.js executable in a release of Nowpose. Without one, returns the name of the installed one.</summary>
    /// <param name="folder">Folder of the program.</param>
    public static string In(string folder)
    {
        var included = Path.Combine(folder, "node", OperatingSystem.IsWindows() ? "node.exe" : "node");
        return File.Exists(included) ? included : "node";
    }

    /// <summary>Starts a script with redirected input, output and error streams.</summary>
    /// <param name="needed">Beginning of the error message, which states what Node.js is needed for.</param>
    /// <param name="prepare">Changes the settings of the process before it starts; null for no changes.</param>
    /// <exception cref="InputException">Node.js is not installed, or was not installed when this program was built.</exception>
    public static Process Start(string needed, string script, IEnumerable<string> arguments, Action<Process> prepare = null)
    {
        if (!File.Exists(script)) throw new InputException(NodeMessages.NotBuilt(needed));
        var process = new Process
        {
            StartInfo = new ProcessStartInfo(In(AppContext.BaseDirectory), [script, .. arguments])
            {
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardInputEncoding = new UTF8Encoding(false),
                StandardOutputEncoding = Encoding.UTF8,
                StandardErrorEncoding = Encoding.UTF8,
            },
        };
        prepare?.Invoke(process);
        try
        {
            process.Start();
            return process;
        }
        catch (Win32Exception e)
        {
            throw new InputException(NodeMessages.NotStarted(needed, e.Message), e);
        }
    }
}
