namespace Nowpose.Messages
{
    /// <summary>Reasons why the Windows performance counter cannot be used.</summary>
    static class CounterMessages
    {
        public static string Missing(string reason) =>
            $"the Windows performance counter was not found ({reason}); on a HoloLens or a PC with Windows, report this line; otherwise, disable the "
            + "component Display Time";

        public static string WentBack(int readings) => $"the performance counter went back in all {readings} readings; restart the device";

        public static string NotWorking(string frequency) =>
            $"the performance counter does not work: its frequency is {frequency}; restart the device";

        public static string FrequencyImplausible(string frequency) =>
            $"the frequency of the performance counter is implausible: {frequency}; restart the device";
    }
}
