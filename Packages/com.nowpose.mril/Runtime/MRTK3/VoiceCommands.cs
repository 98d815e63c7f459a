using System.Collections.Generic;
using MixedReality.Toolkit;
using MixedReality.Toolkit.Subsystems;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Mrtk3
{
    /// <summary>Triggers actions by voice, even while the menu is hidden and wherever the wearer looks.</summary>
    /// <remarks>
    /// Registers its keywords as soon as MRTK3's keyword recognition runs, and unregisters them when this component is disabled. Keywords that
    /// another component registered first stay registered. Buttons can also have keywords, but MRTK3 recognises them only while the button is active;
    /// the keywords of a hand menu work only while the hand is visible.
    /// </remarks>
    [AddComponentMenu("Nowpose/Voice Commands")]
    [DisallowMultipleComponent]
    public sealed class VoiceCommands : MonoBehaviour
    {
        [SerializeField, Tooltip("Phrases and their actions. Empty: speech recognition is off.")]
        List<VoiceCommand> _commands = new List<VoiceCommand>();

        /// <summary>
        /// Delay before a problem is reported. Speech recognition starts some seconds after the scene. It never starts without a microphone or
        /// without its package.
        /// </summary>
        const float ReportDelaySeconds = 10;

        // _registered holds the event of each registered keyword; _own holds the keywords that only this component registered.
        readonly Dictionary<string, UnityEvent> _registered = new Dictionary<string, UnityEvent>();
        readonly HashSet<string> _own = new HashSet<string>();
        IKeywordRecognitionSubsystem _recognition;
        double _since;
        bool _isReported, _isUnsupported;

        public IReadOnlyList<VoiceCommand> Commands => _commands;

        /// <summary>Whether keyword recognition runs.</summary>
        public bool IsListening => _recognition != null && _recognition.running;

        void OnEnable()
        {
            _since = Time.unscaledTimeAsDouble;
            _isReported = false;
            _isUnsupported = false;
        }

        void Update()
        {
            if (_isUnsupported) return;
            if (!IsListening) Find();
            if (IsListening) Register();
        }

        void OnDisable() => Unregister();

        void Find()
        {
            Unregister();
            _recognition = XRSubsystemHelpers.KeywordRecognitionSubsystem;
            if (_recognition != null || _isReported || Time.unscaledTimeAsDouble - _since <= ReportDelaySeconds) return;
            _isReported = true;
            ConsoleLog.Info(this, Mrtk3Messages.VoiceNotRunning(name));
        }

        // Runs in each frame, because another component that unregisters the same keyword removes all listeners of the keyword.
        void Register()
        {
            var known = _recognition.GetAllKeywords();
            if (known == null)
            {
                // MRTK3's recognition for Windows returns null on other platforms and logs an error for each call, so this component does not call it
                // again.
                ConsoleLog.Warn(this, Mrtk3Messages.VoiceNotSupported(name));
                _recognition = null;
                _isUnsupported = true;
                return;
            }
            foreach (var command in _commands)
            {
                var keyword = command.Keyword;
                if (keyword.Length == 0) continue;
                var isKnown = known.TryGetValue(keyword, out var current);
                if (isKnown && _registered.TryGetValue(keyword, out var registered) && registered == current) continue;
                if (!isKnown) _own.Add(keyword);
                Register(keyword);
            }
        }

        void Register(string keyword)
        {
            var heard = _recognition.CreateOrGetEventForKeyword(keyword);
            _registered[keyword] = heard;
            foreach (var command in _commands)
                if (command.Keyword == keyword) heard.AddListener(command.OnHeard.Invoke);
        }

        void Unregister()
        {
            foreach (var command in _commands)
                if (_registered.TryGetValue(command.Keyword, out var heard)) heard.RemoveListener(command.OnHeard.Invoke);
            foreach (var keyword in _own) _recognition.RemoveKeyword(keyword);
            _registered.Clear();
            _own.Clear();
            _recognition = null;
        }
    }
}
