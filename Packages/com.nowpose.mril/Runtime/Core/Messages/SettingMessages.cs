using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about settings.</summary>
    static class SettingMessages
    {
        public const string NotFinite = "must be finite";
        public const string NotPositive = "must be positive and finite";
        public const string Vertices = "must be from 0 to 1000000000 vertices";
        public const string DefaultCellSettings = "virtual cell: the settings are empty; create them with the constructor that has parameters";

        public static string OutOfRange(string name, double value, string suffix, double min, double max) =>
            FormattableString.Invariant($"{name}: {value}{suffix} is out of range; allowed: {min} to {max}{suffix}");

        public static string UnknownNetwork(string name, string allowed) => $"network: '{name}' is unknown; allowed: {allowed}";
    }
}
