using System.ComponentModel;
using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Runs Debian's MQTT broker mosquitto on a free port of loopback. Dispose stops it.</summary>
sealed class Mosquitto : IDisposable
{
    readonly string _file;
    readonly ReservedPort _port = new();
    Process _process;

    Mosquitto(string folder)
    {
        _file = Path.Combine(folder, "mosquitto.conf");
        File.WriteAllText(_file, $"listener {Port} 127.0.0.1\nallow_anonymous true\npersistence false\nlog_dest none\n");
        _process = Start(_file);
    }

    public int Port => _port.Port;

    /// <summary>Starts the broker; ignores the test if it is not installed.</summary>
    public static async Task<Mosquitto> StartAsync(string folder)
    {
        var broker = new Mosquitto(folder);
        await broker.ListensAsync();
        Assert.That(broker._process.HasExited, Is.False, "mosquitto has ended");
        return broker;
    }

    /// <summary>Ends the broker without closing its connections, like a crash.</summary>
    public void Kill()
    {
        _process.Kill();
        _process.WaitForExit();
    }

    /// <summary>Starts the broker again on the same port.</summary>
    public async Task RestartAsync()
    {
        _process.Dispose();
        _process = Start(_file);
        await ListensAsync();
        Assert.That(_process.HasExited, Is.False, "the broker runs again");
    }

    Task ListensAsync() => Soon.BecomesAsync(() => _process.HasExited || Listens(Port), "mosquitto listens");

    static Process Start(string file)
    {
        foreach (var program in new[] { "mosquitto", "/usr/sbin/mosquitto" })
        {
            try
            {
                return Process.Start(new ProcessStartInfo(program, ["-c", file]) { RedirectStandardError = true });
            }
            catch (Win32Exception)
            {
                // Debian installs mosquitto in a folder that only root has in PATH.
            }
        }

        Needs.Program(false, "mosquitto");
        return null;
    }

    static bool Listens(int port)
    {
        try
        {
            using var client = new TcpClient();
            client.Connect(IPAddress.Loopback, port);
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }

    public void Dispose()
    {
        Kill();
        _process.Dispose();
        _port.Dispose();
    }
}
