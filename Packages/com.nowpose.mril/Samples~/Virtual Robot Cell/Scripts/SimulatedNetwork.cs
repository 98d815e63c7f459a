using Nowpose.Simulation;

namespace Nowpose.Samples
{
    /// <summary>Network between the simulated control system and the headset, in the order of <see cref="NetworkProfile.All"/>.</summary>
    public enum SimulatedNetwork
    {
        Lan,
        Wifi,
        BusyWifi,
    }
}
