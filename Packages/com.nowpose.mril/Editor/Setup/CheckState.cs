namespace Nowpose.Editor.Setup
{
    /// <summary>State of a project according to one check.</summary>
    enum CheckState
    {
        /// <summary>The project meets the requirement.</summary>
        Good,

        /// <summary>The project works, but another setting is better or is needed for an optional feature.</summary>
        Advice,

        /// <summary>A part of the app does not work on the headset.</summary>
        Missing,

        /// <summary>The check cannot determine the state.</summary>
        Unknown,
    }
}
