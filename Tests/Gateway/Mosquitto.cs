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
    Process _process;

    Mosquitto(string file, int port)
    {
        (_file, Port) = (file, port);
        _process = Start(file);
    }

    public int Port { get; }

    /// <summary>Starts the broker; ignores the test if it is not installed.</summary>
    public static async Task<Mosquitto> StartAsync(string folder)
    {
        var file = Path.Combine(folder, "mosquitto.conf");
        while (true)
        {
            var port = FreePort();
            await File.WriteAllTextAsync(file, $"listener {port} 127.0.0.1\nallow_anonymous true\npersistence false\nlog_dest none\n");
            var broker = new Mosquitto(file, port);
            await broker.ListensAsync();
            if (!broker._process.HasExited) return broker;
            // Another program has taken the port in the meantime. Any other reason is an error.
            var output = await broker._process.StandardError.ReadToEndAsync();
            broker.Dispose();
            Assert.That(output, Does.Contain("in use"), "the output contains the reason why mosquitto ended");
        }
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

        Assert.Ignore("mosquitto is not installed (apt-get install mosquitto)");
        return null;
    }

    static int FreePort()
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var port = ((IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();
        return port;
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
    }
}
