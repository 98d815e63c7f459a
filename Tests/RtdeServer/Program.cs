using System.CommandLine;
using System.Globalization;
using System.Net;
using System.Text.RegularExpressions;
using Nowpose.Kinematics;
using Nowpose.RtdeServer;

var port = new Option<int>("--port") { Description = "TCP port; 0: any free port", DefaultValueFactory = _ => 30004 };
var series = new Option<string>("--series") { Description = "e (500 control cycles a second) or cb3 (125)", DefaultValueFactory = _ => "e" };
series.AcceptOnlyFromAmong("e", "cb3");
var rate = new Option<double?>("--rate") { Description = "Control cycles a second [default: those of the series]" };
var robot = new Option<string>("--robot") { Description = "ur3e, ur5e, ur10e, ur16e or ur5", DefaultValueFactory = _ => "ur5e" };
robot.AcceptOnlyFromAmong("ur3e", "ur5e", "ur10e", "ur16e", "ur5");
var ppm = new Option<double>("--ppm") { Description = "Rate of the controller's clock minus that of this machine's clock" };
var uptime = new Option<double>("--uptime") { Description = "Time of the controller's clock at startup, s", DefaultValueFactory = _ => 100 };
var fault = new Option<Fault>("--fault") { Description = "Fault to simulate: " + Names() };
fault.CustomParser = result => Find(result.Tokens[0].Value) ?? Fault.None;
fault.Validators.Add(result =>
{
    if (result.Tokens.Count > 0 && Find(result.Tokens[0].Value) == null) result.AddError($"--fault {result.Tokens[0].Value}; allowed: {Names()}");
});
var after = new Option<double>("--after") { Description = "Seconds until the fault begins" };

var command = new RootCommand("Simulates the RTDE interface of a Universal Robots controller whose arm picks and places. Each line of the input "
    + "that names a fault applies it. Ends on Ctrl-C.") { port, series, rate, robot, ppm, uptime, fault, after };
command.SetAction(parsed =>
{
    var isESeries = parsed.GetValue(series) == "e";
    var urdf = Path.Combine(AppContext.BaseDirectory, "Robots", parsed.GetValue(robot) + ".urdf");
    var controller = new Controller(UrdfReader.Read(File.ReadAllText(urdf), urdf), parsed.GetValue(ppm), parsed.GetValue(uptime));
    var server = new RtdeServer(controller, IPAddress.Loopback, parsed.GetValue(port), parsed.GetValue(rate) ?? (isESeries ? 500 : 125), isESeries);
    Console.WriteLine($"endpoint {IPAddress.Loopback}:{server.Port}");
    PrintClock(controller);
    if (parsed.GetValue(after) > 0)
        _ = Task.Delay(TimeSpan.FromSeconds(parsed.GetValue(after))).ContinueWith(_ => server.Apply(parsed.GetValue(fault)), TaskScheduler.Default);
    else
        server.Apply(parsed.GetValue(fault));
    new Thread(server.RunCycles) { IsBackground = true, Priority = ThreadPriority.Highest }.Start();
    _ = server.AcceptAsync();
    Console.WriteLine("state serving");
    ApplyFaultsFromInput(server, controller);
});
return command.Parse(args).Invoke();

static void ApplyFaultsFromInput(RtdeServer server, Controller controller)
{
    while (Console.ReadLine() is { } line)
    {
        if (Find(line.Trim()) is not { } fault)
        {
            Console.WriteLine($"unknown {line}; allowed: {Names()}");
            continue;
        }

        server.Apply(fault);
        PrintClock(controller);
        Console.WriteLine($"done {line.Trim()}");
    }

    // Without an input, the server runs until it is stopped.
    Thread.Sleep(Timeout.Infinite);
}

static void PrintClock(Controller controller)
{
    var (zero, slope) = controller.ClockLine;
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"clock c1_ns = {zero:F0} + {slope:R} * monotonic_ns"));
}

static string Names() => string.Join(", ", Enum.GetValues<Fault>().Select(Name));

// Converts ClockBack to clock-back.
static string Name(Fault fault) => Regex.Replace(fault.ToString(), "(?<!^)(?=[A-Z0-9])", "-").ToLowerInvariant();

static Fault? Find(string name) => Enum.GetValues<Fault>().Cast<Fault?>().FirstOrDefault(fault => Name(fault.Value) == name);
