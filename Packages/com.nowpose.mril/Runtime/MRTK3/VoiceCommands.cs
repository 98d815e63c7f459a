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
    /// <summary>Triggers the menu's actions by voice, even while the menu is hidden, independent of where the wearer looks.</summary>
    /// <remarks>
    /// Registers its keywords with MRTK3's keyword recognition as soon as that runs, and unregisters them when it is disabled. Keywords
    /// that were already registered stay registered. The keyword of a button is recognised only while the button is active, and
    /// those of a hand menu need the hand.
    /// </remarks>
    [AddComponentMenu("Nowpose/Voice Commands")]
    [DisallowMultipleComponent]
    public sealed class VoiceCommands : MonoBehaviour
    {
        [SerializeField, Tooltip("Phrases and their actions. Empty: speech recognition is off.")]
        List<VoiceCommand> _commands = new List<VoiceCommand>();

        /// <summary>Delay before a problem is reported: speech starts some seconds after the scene, or never without microphone or package.</summary>
        const float PatienceSeconds = 10;

        // The event with which each keyword was registered, and the keywords that were not registered before.
        readonly Dictionary<string, UnityEvent> _registered = new Dictionary<string, UnityEvent>();
        readonly HashSet<string> _own = new HashSet<string>();
        IKeywordRecognitionSubsystem _recognition;
        float _since;
        bool _isReported, _isUnsupported;

        public IReadOnlyList<VoiceCommand> Commands => _commands;

        /// <summary>Whether keyword recognition runs.</summary>
        public bool IsListening => _recognition != null && _recognition.running;

        void OnEnable()
        {
            _since = Time.unscaledTime;
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
            if (_recognition != null || _isReported || Time.unscaledTime - _since <= PatienceSeconds) return;
            _isReported = true;
            ConsoleLog.Info(this, Mrtk3Messages.VoiceNotRunning(name));
        }

        // Checked in each frame: another component that unregisters the same keyword removes all its listeners.
        void Register()
        {
            var known = _recognition.GetAllKeywords();
            if (known == null)
            {
                // MRTK3's recognition for Windows on another platform logs an error for each call.
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
