namespace Nowpose.Unity.Cell
{
    /// <summary>Values shown by the toggles and sliders of a menu.</summary>
    readonly struct MenuState
    {
        public MenuState(bool isConnecting, bool isGhostShown, bool isOcclusionOn, bool isPanelShown, float opacity, float nudgeMs, bool isNudgeIdle)
        {
            IsConnecting = isConnecting;
            IsGhostShown = isGhostShown;
            IsOcclusionOn = isOcclusionOn;
            IsPanelShown = isPanelShown;
            Opacity = opacity;
            NudgeMs = nudgeMs;
            IsNudgeIdle = isNudgeIdle;
        }

        public bool IsConnecting { get; }
        public bool IsGhostShown { get; }
        public bool IsOcclusionOn { get; }
        public bool IsPanelShown { get; }
        public float Opacity { get; }
        public float NudgeMs { get; }
        public bool IsNudgeIdle { get; }

        public bool IsSameAs(in MenuState other) =>
            IsConnecting == other.IsConnecting && IsGhostShown == other.IsGhostShown && IsOcclusionOn == other.IsOcclusionOn
            && IsPanelShown == other.IsPanelShown && Opacity == other.Opacity && NudgeMs == other.NudgeMs && IsNudgeIdle == other.IsNudgeIdle;
    }
}
