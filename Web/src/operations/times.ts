/** Converts a time, or a UTC time as text, to local time as text. Includes the date unless it is today. */
export function localTime(utc: string | Date): string {
  const time = new Date(utc);
  const clock = time.toLocaleTimeString('en-GB');
  return time.toDateString() === new Date().toDateString()
    ? clock
    : `${time.toLocaleDateString('en-GB', { day: 'numeric', month: 'short' })} ${clock}`;
}

/** Returns a duration as text, in a suitable unit; a dash if it is unknown. */
export function lengthWords(seconds: number | null | undefined): string {
  if (seconds == null) return '–';
  const of = (value: number, unit: string) => `${value}\u00a0${unit}`;
  if (seconds < 1) return of(Math.round(seconds * 1000), 'ms');
  if (seconds < 10) return of(Number(seconds.toFixed(1)), 's');
  if (seconds < 120) return of(Math.round(seconds), 's');
  return seconds < 7200 ? of(Math.round(seconds / 60), 'min') : of(Math.round(seconds / 3600), 'h');
}

/** Returns the time zone of the times on the page, for example CET. */
export function zone(): string {
  const parts = new Intl.DateTimeFormat('en-GB', { timeZoneName: 'short' }).formatToParts();
  return parts.find(part => part.type === 'timeZoneName')!.value;
}
